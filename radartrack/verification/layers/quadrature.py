"""Layer: the expectation that a quantity's name promises, by Gauss-Hermite quadrature of its definition.

Two orders of quadrature must agree with each other and with the function. Moments of a Taylor polynomial are
integrated the same way, over that polynomial: there the rule is exact.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from math import prod
from typing import Any

import mpmath
import numpy as np
import numpy.typing as npt

from radartrack.derive.algebra.exponential_polynomial import ExponentialPolynomial, ring_over
from radartrack.derive.language.model import Covariance, Model
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.symbolic import Symbol
from radartrack.derive.units import RADIAN
from radartrack.verification.array_program import Program
from radartrack.verification.domain_points import Points, coarse
from radartrack.verification.outcome import Function, Outcome
from radartrack.verification.phase import phase_rates
from radartrack.verification.program_compilation import compiled
from radartrack.verification.second_derivations.definitions import ROWS, defined
from radartrack.verification.second_derivations.power_series import Jet, jets
from radartrack.verification.subject import evaluated, model_of, quantity_of, relative, row_of, scale_of

NAME = "quadrature"
RELATIVE = 1e-9
ORDERS = (10, 13)
POLYNOMIAL_ORDER = 4  # exact to degree seven in what is not an angle
BLOCK = 64
ZERO = 2.0**-48  # of what meets in an entry; less is rounding
MOST_NODES = 2 * 10**7  # of an average, or of an average of averages
NESTED = {"bias.averaged", "covariance.averaged", "decorrelated.covariance", "unbiased.covariance.averaged"}
Array = npt.NDArray[np.float64]
Point = Mapping[str, Array]
TAYLOR = {
    "bias.second_order": ("bias.truth", 2),
    "covariance.linear": ("covariance.truth", 1),
    "covariance.second_order": ("covariance.truth", 2),
    "covariance.third_order": ("covariance.truth", 3),
}


@dataclass(frozen=True)
class Field:
    """A function of the measured quantities, evaluated on arrays of any shape."""

    at: Callable[[Point], Array]

    def __add__(self, other: Field) -> Field:
        return Field(lambda point: self.at(point) + other.at(point))

    def __sub__(self, other: Field) -> Field:
        return Field(lambda point: self.at(point) - other.at(point))

    def __mul__(self, other: Field) -> Field:
        return Field(lambda point: self.at(point) * other.at(point))


@dataclass(frozen=True)
class Rule:
    """Nodes w of N(0, K) and their weights, at one point's deviations and correlations."""

    names: tuple[str, ...]
    offsets: Array
    weights: Array

    @classmethod
    def of(cls, names: Sequence[str], covariance: Array, orders: Sequence[int]) -> Rule:
        """A product rule along the axes of a Cholesky factor that begins with the highest order.

        So what is correlated with an angle takes part in the angle's many nodes.
        """
        ranked = sorted(range(len(names)), key=lambda i: -orders[i])
        factor = np.linalg.cholesky(covariance[np.ix_(ranked, ranked)])
        rules = [np.polynomial.hermite_e.hermegauss(orders[i]) for i in ranked]
        nodes = np.stack(np.meshgrid(*(nodes for nodes, _ in rules), indexing="ij"), axis=-1)
        weights = np.stack(np.meshgrid(*(weights for _, weights in rules), indexing="ij"), axis=-1).prod(axis=-1)
        moved = nodes.reshape(-1, len(names)) @ factor.T
        return cls(tuple(names[i] for i in ranked), moved, weights.ravel() / weights.sum())

    def average(self, field: Field) -> Field:
        """θ ↦ E[f(θ + w)]."""

        def at(point: Point) -> Array:
            total: Array = np.zeros(np.broadcast_shapes(*(value.shape for value in point.values())))
            for start in range(0, len(self.weights), BLOCK):
                part = slice(start, start + BLOCK)
                moved = {n: point[n][..., None] + self.offsets[part, i] for i, n in enumerate(self.names)}
                kept = {n: value[..., None] for n, value in point.items() if n not in moved}
                values = np.broadcast_to(field.at({**kept, **moved}), (*total.shape, len(self.weights[part])))
                total = total + values @ self.weights[part]
            return total

        return Field(at)


@dataclass(frozen=True)
class Quadrature:
    """The function against the definition.

    Attributes:
        points: at how many random points.
        seed: of the points.
    """

    points: int = 1
    seed: int = 0
    name: str = NAME

    def __call__(self, quantity: Quantity, function: Function) -> Outcome:
        """The largest relative difference."""
        reason = not_applicable(quantity)
        if reason:
            return Outcome.not_applicable(NAME, reason)
        points, coarser, finer = _references(quantity, self.points, self.seed)
        scale = _scale(quantity, finer, _sizes(quantity, points))
        unsettled = relative(coarser, finer, scale)
        if row_of(quantity) == "unbiased.estimate":
            found = _mean_of_estimate(quantity, function, points)
        else:
            found = evaluated(function, quantity, points)
        figure = max(relative(found, finer, scale), unsettled)
        detail = f"{self.points} points, orders {ORDERS[0]} and {ORDERS[1]} differ by {unsettled:.1g}"
        return Outcome.measured(NAME, figure, RELATIVE, detail)


def nodes(model: Model, order: int, degree: int | None = None) -> list[int]:
    """How many along each measured quantity: many where the map is a wave or an exponential, else as its degree asks.

    Args:
        model: whose map is averaged.
        order: along waves.
        degree: of the Taylor polynomial that stands for the map; None for the map itself.
    """
    if degree is not None:
        return [degree + 1] * len(model.measured)
    rates = phase_rates(model)
    few = max(POLYNOMIAL_ORDER, _degree(model) + 1)
    return [order if variable.unit == RADIAN or variable in rates else few for variable in model.measured]


@cache
def _degree(model: Model) -> int:
    """The highest total degree of the measured quantities beside waves."""
    ring = ring_over(model.arguments)
    places = [ring.symbols.index(variable) for variable in model.measured]
    waves = (ExponentialPolynomial.read(h, ring) for h in model.map)
    monomials = (m for wave in waves for coefficient in wave.terms.values() for m, _ in coefficient.terms())
    return max((sum(monomial[place] for place in places) for monomial in monomials), default=0)


def not_applicable(quantity: Quantity) -> str:
    """Why there is nothing to integrate; empty where there is."""
    model, row = model_of(quantity), row_of(quantity)
    if model is None or row in {"map", "jacobian", "hessian"}:
        return "its definition is no expectation over measurement errors"
    if row in ROWS and prod(nodes(model, ORDERS[1])) ** (2 if row in NESTED else 1) > MOST_NODES:
        return "an average with more nodes than can be summed; the proof and simulated errors decide it"
    if row in ROWS or row in TAYLOR:
        return ""
    if row.startswith("std"):
        return "roots of the linear covariance, which is integrated by itself"
    if row.startswith("validity"):
        return "a term of a series by definition; direct power series decide it"
    return "cut off at an order, so it is not equal to its expectation; direct power series decide it"


@cache
def _references(quantity: Quantity, count: int, seed: int) -> tuple[Points, Array, Array]:
    """Points, and the definition there at two orders."""
    points = coarse(quantity, count, seed + 5)
    rows = [{name: values[n] for name, values in points.items()} for n in range(count)]
    coarser, finer = (np.stack([_by_definition(quantity, row, order) for row in rows]) for order in ORDERS)
    return points, coarser, finer


def _by_definition(quantity: Quantity, point: Mapping[str, float], order: int) -> Array:
    model, row = _model(quantity), row_of(quantity)
    word, degree = TAYLOR.get(row, (row, None))
    of = Integrals(model, dict(point), order, degree)
    at = {name: np.asarray(value, dtype=np.float64) for name, value in point.items()}
    fields = of.h if row == "unbiased.estimate" else list(defined(word, of))
    known: dict[Field, Array] = {field: field.at(at) for field in fields}
    return np.array([known[field] for field in fields]).reshape(quantity.shape)


def _mean_of_estimate(quantity: Quantity, function: Function, points: Points) -> Array:
    """E[u(θ + w)], which must be h(θ)."""
    count = len(next(iter(points.values())))
    model = _model(quantity)
    means = []
    for n in range(count):
        at = {name: np.asarray(values[n]) for name, values in points.items()}
        rule = Integrals(model, {name: float(value) for name, value in at.items()}, ORDERS[1]).rule(model.covariance)
        means.append([rule.average(Field(_component(quantity, function, a))).at(at) for a in range(*quantity.shape)])
    return np.array(means)


def _sizes(quantity: Quantity, points: Points) -> Array:
    """How large the numbers are that an entry is the difference of: a bias may vanish, and its rounding does not."""
    model = _model(quantity)
    sizes = np.abs(_map(model)(**{symbol.name: points[symbol.name] for symbol in model.arguments}))
    return sizes if len(quantity.shape) == 1 else sizes[..., :, np.newaxis] * sizes[..., np.newaxis, :]


def _scale(quantity: Quantity, values: Array, sizes: Array) -> Array:
    """That of the values; what meets in them, where they are its rounding, as of a coordinate that has no error."""
    scale = scale_of(quantity, np.where(np.abs(values) > ZERO * sizes, values, 0.0))
    return np.where(scale > ZERO * sizes, scale, sizes)


def _component(quantity: Quantity, function: Function, a: int) -> Callable[[Point], Array]:
    names = [symbol.name for symbol in quantity.symbols]
    return lambda point: np.asarray(function(**{name: point[name] for name in names}), dtype=np.float64)[..., a]


@dataclass(frozen=True)
class Integrals:
    """A model with the errors of one point.

    Attributes:
        model: whose map is averaged.
        errors: the numbers of its symbols.
        order: nodes for an angle.
        degree: of the Taylor polynomial that stands for the map; None for the map itself.
    """

    model: Model
    errors: Mapping[str, float]
    order: int
    degree: int | None = None

    @cached_property
    def h(self) -> list[Field]:
        """The coordinates."""
        if self.degree is not None:
            return [_polynomial(jet, self.model, self.errors) for jet in self._jets(self.degree)]
        return _fields(_map(self.model))

    @cached_property
    def u(self) -> list[Field]:
        """The derived unbiased estimate; that its mean is h is checked by itself."""
        return _fields(_estimate(self.model))

    def noise(self, value: Field) -> Field:
        """Average over the measurement error."""
        return self.rule(self.model.covariance).average(value)

    def prediction(self, value: Field) -> Field:
        """Average over the error of a prediction."""
        return self.rule(self.model.prediction_covariance).average(value)

    def rule(self, covariance: Covariance) -> Rule:
        """The nodes for one covariance."""
        size = len(self.model.measured)
        entries = Tensor((size, size), tuple(entry for row in covariance for entry in row))
        symbols = [symbol for symbol in self.model.symbols if symbol.name in self.errors]
        numbers = compiled(entries, symbols)(**{symbol.name: self.errors[symbol.name] for symbol in symbols})
        orders = nodes(self.model, self.order, self.degree)
        return Rule.of([variable.name for variable in self.model.measured], numbers, orders)

    def _jets(self, degree: int) -> list[Jet]:
        at: dict[Symbol, Any] = {s: mpmath.mpf(self.errors[s.name]) for s in self.model.arguments}
        return jets(list(self.model.map), at, self.model.measured, degree)


def _polynomial(jet: Jet, model: Model, errors: Mapping[str, float]) -> Field:
    names = [variable.name for variable in model.measured]
    terms = [(powers[:-1], float(value)) for powers, value in jet.terms.items() if value]

    def at(point: Point) -> Array:
        moved = [point[name] - errors[name] for name in names]
        total = np.zeros(np.broadcast_shapes(*(value.shape for value in moved)))
        for powers, value in terms:
            term = np.full(total.shape, value)
            for offset, power in zip(moved, powers, strict=True):
                for _ in range(power):
                    term = term * offset
            total = total + term
        return total

    return Field(at)


def _fields(program: Program) -> list[Field]:
    return [Field(_entry(program, a)) for a in range(program.shape[0])]


def _entry(program: Program, a: int) -> Callable[[Point], Array]:
    single = Program(program.arguments, program.constants, program.steps, (program.results[a],), ())
    return lambda point: np.asarray(single.entries(point)[0], dtype=np.float64)


def _model(quantity: Quantity) -> Model:
    model = model_of(quantity)
    if model is None:
        raise LookupError(f"{quantity.name} belongs to no measurement model")
    return model


@cache
def _map(model: Model) -> Program:
    return compiled(model.map, model.arguments)


@cache
def _estimate(model: Model) -> Program:
    quantity = quantity_of(model, "unbiased.estimate")
    return compiled(quantity.expression, quantity.symbols)
