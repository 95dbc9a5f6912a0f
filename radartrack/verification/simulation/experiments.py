"""Which simulation a quantity is the mean of."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from itertools import combinations_with_replacement

import numpy as np
import numpy.typing as npt

from radartrack.derive.catalogue import catalogue, family
from radartrack.derive.evaluation.many_digits import Evaluator
from radartrack.derive.language.model import Covariance, Model
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.tensor import Tensor
from radartrack.verification.array_program import Program
from radartrack.verification.domain_points import coarse, is_deviation
from radartrack.verification.outcome import Function
from radartrack.verification.program_compilation import compiled
from radartrack.verification.simulation.draws import Experiment, Slopes, Term
from radartrack.verification.subject import model_of, quantity_of, row_of

Array = npt.NDArray[np.float64]
POINTS = 2
WITNESSES = 64  # draws at which two ways to compute one estimate are compared
ROUNDING = 2.0**-49  # some multiple of the rounding of one double
NOISE, PREDICTION = "noise", "prediction"
Departures = tuple[float, ...]  # by how much each mean moves


@dataclass(frozen=True)
class Recipe:
    """What is drawn, and whose mean the quantity is.

    Attributes:
        errors: the distribution of each error that is drawn.
        terms: of g.
        factor: of the second moment E[g gᵀ], or None where the mean E[g] itself is meant.
    """

    errors: tuple[str, ...]
    terms: tuple[Term, ...]
    factor: float | None


def _mean(errors: tuple[str, ...], *terms: Term) -> Recipe:
    return Recipe(errors, terms, None)


def _square(factor: float, errors: tuple[str, ...], *terms: Term) -> Recipe:
    return Recipe(errors, terms, factor)


"""A covariance is half the mean square of the difference of two draws; what is averaged over the truth shares it."""
RECIPES: dict[str, Recipe] = {
    "bias.truth": _mean((NOISE,), Term(1, (1,), "h"), Term(-1, (0,), "h")),
    "bias.averaged": _mean((NOISE, NOISE), Term(1, (-1, 1), "h"), Term(-1, (-1, 0), "h")),
    "unbiased.estimate": _mean((NOISE,), Term(1, (1,), "tested"), Term(-1, (0,), "h")),
    "posterior.estimate": _mean((NOISE,), Term(1, (-1,), "h")),
    "covariance.truth": _square(0.5, (NOISE, NOISE), Term(1, (1, 0), "h"), Term(-1, (0, 1), "h")),
    "posterior.covariance": _square(0.5, (NOISE, NOISE), Term(1, (-1, 0), "h"), Term(-1, (0, -1), "h")),
    "covariance.averaged": _square(0.5, (NOISE, NOISE, NOISE), Term(1, (-1, 1, 0), "h"), Term(-1, (-1, 0, 1), "h")),
    "unbiased.covariance": _square(1.0, (NOISE,), Term(1, (0,), "u"), Term(-1, (-1,), "h")),
    "decorrelated.covariance": _square(1.0, (PREDICTION, NOISE), Term(1, (-1, 1), "u"), Term(-1, (-1, 0), "h")),
}


def simulated(quantity: Quantity) -> bool:
    """Whether a quantity is the mean of a simulation."""
    return model_of(quantity) is not None and row_of(quantity) in RECIPES


def tests_of(quantity: Quantity) -> int:
    """How many means are compared at all its points."""
    size = quantity.shape[0]
    return POINTS * (size if RECIPES[row_of(quantity)].factor is None else size * (size + 1) // 2)


@cache
def tests_of_catalogue() -> int:
    """How many means a run over the whole catalogue compares; the false alarms of all are one budget."""
    return sum(tests_of(quantity) for quantity in catalogue().values() if simulated(quantity))


def budget(quantity: Quantity) -> int:
    """How many means share their false alarms with those of a quantity: the catalogue's, or its own model's."""
    if catalogue().get(quantity.name) == quantity:
        return tests_of_catalogue()
    return sum(tests_of(other) for other in family(quantity) if simulated(other))


@dataclass(frozen=True)
class Polynomial:
    """c(w) = constant + linear·w + wᵀ quadratic w/2, one row a component, over all errors stacked."""

    constant: Array
    linear: Array
    quadratic: Array

    def means(self, covariance: Array) -> Array:
        """E[c], one a component."""
        return np.asarray(self.constant + 0.5 * np.einsum("aij,ij->a", self.quadratic, covariance))

    def second_moments(self, covariance: Array) -> Array:
        """E[c_a c_b] = mean mean + linear K linear + tr(quadratic K quadratic K)/2."""
        means, spread = self.means(covariance), self.quadratic @ covariance
        linear = self.linear @ covariance @ self.linear.T
        return np.asarray(np.outer(means, means) + linear + 0.5 * np.einsum("aij,bji->ab", spread, spread))


@dataclass(frozen=True)
class Trial:
    """One quantity at one point: the simulation, and what it should give.

    Attributes:
        experiment: what is drawn.
        finite: whether the function gave numbers.
        rounding: how far rounding alone may move each mean; more draws do not make it smaller.
        scale: what errors of each mean are relative to.
        factor: by which a mean is multiplied to be an entry of the quantity.
        labels: the index of each mean.
        beyond: for each mean the size, relative to the scale, of what the second-order formulas leave out.
    """

    experiment: Experiment
    finite: bool
    rounding: tuple[float, ...]
    scale: tuple[float, ...]
    factor: float
    labels: tuple[str, ...]
    beyond: tuple[float, ...]


def trials(quantity: Quantity, function: Function, seed: int) -> Iterator[Trial]:
    """A trial at each point."""
    columns = coarse(quantity, POINTS, seed + 6)
    for number in range(POINTS):
        point = {name: float(values[number]) for name, values in columns.items()}
        yield _trial(quantity, function, _small(quantity, point, number), f"{seed}/{quantity.name}/{number}")


def departures(quantity: Quantity, trial: Trial, function: Function, other: Function) -> Departures:
    """How far each mean of a trial moves when another function takes the place of the one it was planned for.

    An estimate enters at every draw. Where the two are equal they are equal at each, so few draws show by how much
    their means differ; any other quantity enters by its value at the point.
    """
    experiment = trial.experiment
    at = {symbol.name: np.asarray(experiment.point[symbol.name]) for symbol in quantity.symbols}
    sign = -1.0 / trial.factor
    if row_of(quantity) == "unbiased.estimate":
        sign = 1.0
        normals = np.random.Generator(np.random.Philox(WITNESSES)).standard_normal((WITNESSES, len(experiment.names)))
        errors = normals @ experiment.factors[0].T
        at |= {name: at[name] + errors[:, i] for i, name in enumerate(experiment.names)}
    with np.errstate(all="ignore"):
        gap = np.asarray(other(**at), dtype=np.float64) - np.asarray(function(**at), dtype=np.float64)
    gap = gap.reshape(-1, *quantity.shape).mean(axis=0)
    places = experiment.pairs or [(a,) for a in range(*quantity.shape)]
    return tuple(sign * float(gap[place]) for place in places)


def _small(quantity: Quantity, point: Mapping[str, float], number: int) -> dict[str, float]:
    """Every second point has errors three times smaller, where the orders of a formula stand apart."""
    sigmas = {symbol.name for symbol in quantity.symbols if is_deviation(quantity, symbol)}
    return {name: value / 3 if name in sigmas and number % 2 else value for name, value in point.items()}


def _trial(quantity: Quantity, function: Function, point: dict[str, float], key: str) -> Trial:
    model, recipe = model_of(quantity), RECIPES[row_of(quantity)]
    if model is None:
        raise LookupError(f"{quantity.name} belongs to no measurement model")
    names = {NOISE: model.covariance, PREDICTION: model.prediction_covariance}
    covariances = [_numbers(model, names[error], point) for error in recipe.errors]
    whole, starts = _stacked(covariances), _starts(model, recipe, point)
    slopes = Slopes(_exact(model, "jacobian", point), _exact(model, "hessian", point))
    control = _control(recipe, starts, slopes)
    size, factor = len(model.outputs), recipe.factor or 1.0
    pairs = tuple(combinations_with_replacement(range(size), 2)) if recipe.factor is not None else ()
    places: tuple[tuple[int, ...], ...] = pairs or tuple((a,) for a in range(size))
    value = np.asarray(function(**{s.name: point[s.name] for s in quantity.symbols}), dtype=np.float64)
    target = np.zeros(size) if row_of(quantity) == "unbiased.estimate" else value
    known = control.second_moments(whole) if pairs else control.means(whole)
    scale = _scale(quantity, value)
    sizes = _sizes(recipe, starts, control, whole) + _terms(model, slopes, point)
    expected = [float(target[place] / factor - known[place]) for place in places]
    rounding = [ROUNDING * math.prod(sizes[a] for a in place) for place in places]
    relative = [float(scale[place]) or math.prod(float(sizes[a]) for a in place) or 1.0 for place in places]
    experiment = Experiment(
        key,
        point,
        tuple(variable.name for variable in model.measured),
        tuple(np.asarray(np.linalg.cholesky(k), dtype=np.float64) for k in covariances),
        recipe.terms,
        _functions(quantity, model, recipe, function),
        control.constant,
        slopes,
        pairs,
        tuple(expected),
    )
    labels = tuple(str(list(place)) for place in places)
    left = tuple(abs(gap) * factor / unit for gap, unit in zip(expected, relative, strict=True))
    finite = all(map(math.isfinite, expected))
    return Trial(experiment, finite, tuple(rounding), tuple(relative), factor, labels, left)


def _sizes(recipe: Recipe, starts: Mapping[str, Array], control: Polynomial, covariance: Array) -> Array:
    """How large the numbers are that meet in each component of g, before they cancel."""
    largest = sum(np.abs(starts[term.value]) for term in recipe.terms)
    return np.asarray(largest + np.sqrt(np.diagonal(control.second_moments(covariance))))


def _terms(model: Model, slopes: Slopes, point: Mapping[str, float]) -> Array:
    """How large what is rounded inside of the map is: terms that cancel there leave their rounding."""
    at = np.array([point[variable.name] for variable in model.measured])
    return np.asarray(np.abs(slopes.jacobian) @ np.abs(at))


def _functions(
    quantity: Quantity, model: Model, recipe: Recipe, function: Function
) -> dict[str, Program | tuple[Function, tuple[str, ...]]]:
    known: dict[str, Program | tuple[Function, tuple[str, ...]]] = {
        "h": _program(model, "map"),
        "tested": (function, tuple(symbol.name for symbol in quantity.symbols)),
    }
    used = {term.value for term in recipe.terms}
    if "u" in used:
        known["u"] = _program(model, "unbiased.estimate")
    return {name: value for name, value in known.items() if name in used}


@cache
def _program(model: Model, row: str) -> Program:
    quantity = quantity_of(model, row)
    return compiled(quantity.expression, quantity.symbols)


def _exact(model: Model, row: str, point: Mapping[str, float]) -> Array:
    """A derived quantity at the point, in many digits before it is rounded."""
    quantity = quantity_of(model, row)
    values = Evaluator(quantity.expression, quantity.symbols)([point[s.name] for s in quantity.symbols])
    return np.array([float(value) for value in values]).reshape(quantity.shape)


def _scale(quantity: Quantity, value: Array) -> Array:
    if quantity.is_covariance:
        deviations = np.sqrt(np.abs(np.diagonal(value)))
        return np.outer(deviations, deviations)
    return np.abs(value)


def _numbers(model: Model, covariance: Covariance, point: Mapping[str, float]) -> Array:
    size = len(model.measured)
    symbols = [symbol for symbol in model.symbols if symbol.name in point]
    entries = Tensor((size, size), tuple(entry for row in covariance for entry in row))
    return compiled(entries, symbols)(**{symbol.name: point[symbol.name] for symbol in symbols})


def _stacked(covariances: list[Array]) -> Array:
    size = sum(map(len, covariances))
    whole, start = np.zeros((size, size)), 0
    for covariance in covariances:
        stop = start + len(covariance)
        whole[start:stop, start:stop] = covariance
        start = stop
    return whole


def _starts(model: Model, recipe: Recipe, point: Mapping[str, float]) -> dict[str, Array]:
    """What each function of g is at the point; an estimate that is tested has nearly the value of the map."""
    starts = {"h": _exact(model, "map", point)}
    starts["tested"] = starts["h"]
    if any(term.value == "u" for term in recipe.terms):
        starts["u"] = _exact(model, "unbiased.estimate", point)
    return starts


def _control(recipe: Recipe, starts: Mapping[str, Array], slopes: Slopes) -> Polynomial:
    """Taylor's polynomial of g: that of the map at each displacement; estimates have nearly the map's own slopes."""
    size, inputs = slopes.jacobian.shape
    whole = inputs * len(recipe.errors)
    constant, linear, quadratic = np.zeros(size), np.zeros((size, whole)), np.zeros((size, whole, whole))
    for term in recipe.terms:
        often = np.array(term.displacement, dtype=np.float64)
        constant = constant + term.sign * starts[term.value]
        linear = linear + term.sign * np.concatenate([times * slopes.jacobian for times in often], axis=1)
        quadratic = quadratic + term.sign * np.stack([np.kron(np.outer(often, often), part) for part in slopes.hessian])
    return Polynomial(constant, linear, quadratic)
