"""Layer: two independent derivations of a quantity are the same function.

Moments in closed form are derived again from derivatives of the moment generating function and proved equal in a
ring where equality is decidable. Quantities that are series are compared with direct power series, filters with least
squares over fractions, maps with the observation maps that undo them: there the figure is the largest relative
difference at a few random points, carried out in so many digits that agreement is no accident.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

import mpmath

from radartrack.derive.algebra.exponential_polynomial import ExponentialPolynomial, NotExponentialPolynomial
from radartrack.derive.catalogue import catalogue
from radartrack.derive.evaluation.many_digits import Evaluator
from radartrack.derive.language.model import Model
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.tensor import Tensor, indices
from radartrack.derive.sensors import models
from radartrack.derive.symbolic import Symbol
from radartrack.verification.domain_points import coarse
from radartrack.verification.outcome import Function, Outcome
from radartrack.verification.second_derivations.definitions import ROWS, defined
from radartrack.verification.second_derivations.direct_series import derivatives, direct
from radartrack.verification.second_derivations.elementary_quantities import ELEMENTARY
from radartrack.verification.second_derivations.exact_least_squares import least_squares
from radartrack.verification.second_derivations.moment_generating_function import GeneratingFunction
from radartrack.verification.second_derivations.power_series import jets
from radartrack.verification.subject import model_of, quantity_of, row_of

NAME = "identity"
DIGITS = 60
AGREEMENT = 1e-40
POINTS = 2
Number = Any
Numbers = tuple[Tensor[Number], ...]


@dataclass(frozen=True)
class Identity:
    """The derivation of a quantity against a second one.

    Attributes:
        seed: of the random points, where points are needed.
    """

    seed: int = 0
    name: str = NAME

    def __call__(self, quantity: Quantity, function: Function) -> Outcome:  # noqa: ARG002 - one interface for all
        """Compares derivations; what was generated from the first one is proved equal to it when it is written."""
        model = model_of(quantity)
        if model is not None and row_of(quantity) in ROWS:
            return _proof(quantity)
        figure = _largest_difference(quantity, self.seed)
        return Outcome.measured(NAME, figure, AGREEMENT, f"{_method(quantity)}, at {POINTS} random points")


def _proof(quantity: Quantity) -> Outcome:
    model = _model(quantity)
    generating = _generating(model)
    try:
        found = [generating.read(entry) for entry in quantity.expression]
    except NotExponentialPolynomial as error:
        return Outcome.failed(NAME, f"not polynomial × trigonometric: {error}")
    second = _second(model, row_of(quantity))
    wrong = [
        str(list(index))
        for index, first, other in zip(indices(quantity.shape), found, second, strict=True)
        if first != other
    ]
    said = f"entries {', '.join(wrong)} differ from" if wrong else "proved equal to"
    return Outcome.measured(NAME, float(len(wrong)), 0.0, f"{said} derivatives of the moment generating function")


def _model(quantity: Quantity) -> Model:
    model = model_of(quantity)
    if model is None:
        raise LookupError(f"{quantity.name} belongs to no measurement model")
    return model


@cache
def _generating(model: Model) -> GeneratingFunction:
    return GeneratingFunction(model)


@cache
def _second(model: Model, row: str) -> Tensor[ExponentialPolynomial]:
    return defined(row, _generating(model))


def _method(quantity: Quantity) -> str:
    """How the second derivation goes, in words."""
    if quantity.name in ELEMENTARY:
        return ELEMENTARY[quantity.name].method
    if quantity.module == "finite_sample":
        return "exact least squares over fractions"
    if quantity.module == "observe":
        return "the conversion undoes it" if _is_undone(quantity) else "power series of the map"
    return f"observe.{quantity.module}.map undoes it" if _is_undone(quantity) else "direct power series of the map"


def _is_undone(quantity: Quantity) -> bool:
    """Whether it is a map that another one takes back: a conversion, or what is observed of a position."""
    name, _, kind = row_of(quantity).rpartition(".")
    if quantity.module == "observe":
        return kind == "map" and name in models()
    return row_of(quantity) == "map" and models().get(quantity.module) is model_of(quantity) is not None


def _largest_difference(quantity: Quantity, seed: int) -> float:
    evaluator = Evaluator(quantity.expression, quantity.symbols, DIGITS)
    largest = 0.0
    with mpmath.workdps(DIGITS):
        for point, expected in zip(_points(quantity, seed), _references(quantity, seed), strict=True):
            found = _composed(quantity, point, evaluator(point))
            if found.shape != expected.shape:
                return float("inf")
            largest = max(largest, _difference(found, expected))
        if quantity.module == "observe" and _is_undone(quantity):
            largest = max(largest, _returned(quantity, seed))
    return largest


def _returned(quantity: Quantity, seed: int) -> float:
    """How far what is observed of a converted measurement is from the measurement.

    Undoing does not tell this: a path that is the difference of two distances is converted to where it came from, too.
    """
    model = models()[row_of(quantity).rpartition(".")[0]]
    conversion = quantity_of(model, "map")
    largest = 0.0
    for point in _points(conversion, seed):
        given = Tensor((len(model.measured),), tuple(mpmath.mpf(point[variable.name]) for variable in model.measured))
        coordinates = _values(conversion, [mpmath.mpf(point[symbol.name]) for symbol in conversion.symbols])
        found = _measured(model, Tensor((len(coordinates),), coordinates), point, quantity)
        largest = max(largest, _difference(found, given))
    return largest


def _points(quantity: Quantity, seed: int) -> list[dict[str, float]]:
    columns = coarse(quantity, POINTS, seed + 1)
    return [{name: float(values[n]) for name, values in columns.items()} for n in range(POINTS)]


@cache
def _references(quantity: Quantity, seed: int) -> Numbers:
    """The second derivation at each point; a quantity with the same name has the same."""
    with mpmath.workdps(DIGITS):
        return tuple(_reference(quantity, point) for point in _points(quantity, seed))


def _reference(quantity: Quantity, point: Mapping[str, float]) -> Tensor[Number]:
    model, row = model_of(quantity), row_of(quantity)
    at: dict[Symbol, Number] = {symbol: mpmath.mpf(point[symbol.name]) for symbol in quantity.symbols}
    if quantity.name in ELEMENTARY:
        return ELEMENTARY[quantity.name].values({symbol.name: value for symbol, value in at.items()})
    if quantity.module == "finite_sample":
        found = least_squares(row, point)
    elif quantity.module == "observe":
        found = _observed(quantity, at)
    elif model is not None and _is_undone(quantity):
        found = Tensor((len(model.measured),), tuple(at[variable] for variable in model.measured))
    else:
        found = direct(row, model, _complete(model, at)) if model is not None else None
    if found is None:
        raise LookupError(f"{quantity.name} has no second derivation")
    return found


def _complete(model: Model, at: Mapping[Symbol, Number]) -> dict[Symbol, Number]:
    """The numbers of all symbols of a model; those that a quantity does not depend on may have any."""
    return {symbol: mpmath.mpf(symbol.high) / 16 for symbol in model.symbols} | dict(at)


def _observed(quantity: Quantity, at: Mapping[Symbol, Number]) -> Tensor[Number]:
    name, _, kind = row_of(quantity).rpartition(".")
    symbols = quantity.symbols
    if _is_undone(quantity):
        state = {symbol.name: at[symbol] for symbol in symbols}
        if name == "ruv":  # an array sees what is in front of it: its direction cosines do not tell behind
            state["z"] = abs(state["z"])
        return Tensor((len(state),), tuple(state.values()))
    order = {"map": 0, "jacobian": 1, "hessian": 2}[kind]
    inputs = symbols[: quantity.shape[-1]] if order else ()  # the state; where receivers stand comes after it
    observed = catalogue()[f"observe.{name}.map"].expression
    return derivatives(jets(list(observed), at, inputs, order), order, len(inputs))


def _composed(quantity: Quantity, point: Mapping[str, float], found: Tensor[Number]) -> Tensor[Number]:
    """What a map gives, taken back by the map that undoes it; anything else as it is."""
    if not _is_undone(quantity):
        return found
    model = model_of(quantity)
    if model is None:
        return _state(quantity, found, point)
    return _measured(model, found, point, catalogue()[f"observe.{model.name}.map"])


def _measured(model: Model, found: Tensor[Number], point: Mapping[str, float], observe: Quantity) -> Tensor[Number]:
    """The measured quantities from coordinates; a range rate from the pseudo-measurement and the range."""
    coordinates = dict(zip(model.outputs, found, strict=True))
    known = {name: mpmath.mpf(value) for name, value in point.items()} | coordinates
    seen = list(_values(observe, [known.get(symbol.name, mpmath.mpf(0)) for symbol in observe.symbols]))
    if "eta" in coordinates:
        names = [variable.name for variable in model.measured]
        seen[names.index("rdot")] = coordinates["eta"] / known["r"]
    return Tensor((len(seen),), tuple(seen))


def _state(quantity: Quantity, found: Tensor[Number], point: Mapping[str, float]) -> Tensor[Number]:
    """The state from what is observed; the velocity as it was, if its radial part is right."""
    model = models()[row_of(quantity).rpartition(".")[0]]
    given = {name: mpmath.mpf(value) for name, value in point.items()}
    parameters = [given[symbol.name] for symbol in model.parameters]
    coordinates = dict(zip(model.outputs, _values(quantity_of(model, "map"), [*found, *parameters]), strict=True))
    if "eta" in coordinates:
        speeds = {f"v{axis}": given[f"v{axis}"] for axis in coordinates if axis != "eta"}
        radial = sum((given[name.removeprefix("v")] * speed for name, speed in speeds.items()), mpmath.mpf(0))
        coordinates |= {name: speed * coordinates["eta"] / radial for name, speed in speeds.items()}
    state = [coordinates.get(symbol.name, given[symbol.name]) for symbol in quantity.symbols]
    return Tensor((len(state),), tuple(state))


def _values(quantity: Quantity, numbers: list[Number]) -> tuple[Number, ...]:
    return Evaluator(quantity.expression, quantity.symbols, DIGITS)(numbers).entries


def _difference(found: Tensor[Number], expected: Tensor[Number]) -> float:
    """The largest difference of an entry by the entry; what is nothing but rounding, by the largest entry."""
    size = max(abs(value) for value in expected) or mpmath.mpf(1)
    scales = [abs(value) if abs(value) > AGREEMENT * size else size for value in expected]
    differences = [abs(first - second) / s for first, second, s in zip(found, expected, scales, strict=True)]
    return max(float(mpmath.re(d)) if mpmath.isfinite(d) and mpmath.im(d) == 0 else float("inf") for d in differences)
