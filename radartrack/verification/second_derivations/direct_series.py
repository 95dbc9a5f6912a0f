"""Quantities of any smooth model from direct power series at a point, to compare with what the operator gives."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import factorial
from typing import Any

import mpmath

from radartrack.derive.evaluation.many_digits import evaluate
from radartrack.derive.language.model import Covariance, Model
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.moments.validity_of_linearisation import NEGLECTED
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.verification.second_derivations.definitions import ROWS, defined
from radartrack.verification.second_derivations.power_series import Jet, Powers, averaged, jets

Number = Any
ORDERS = {"second_order": 2, "fourth_order": 4}


@dataclass(frozen=True)
class DirectSeries:
    """A model at one point.

    Attributes:
        model: whose map is expanded.
        at: the value of every symbol of the model.
        degree: the highest total degree in displacement and errors.
        polynomial: the degree of the Taylor polynomial that stands for the map; all of it by default.
    """

    model: Model
    at: Mapping[Symbol, Number]
    degree: int
    polynomial: int | None = None

    @cached_property
    def h(self) -> list[Jet]:
        """The coordinates as functions of the displacement."""
        whole = jets(list(self.model.map), self.at, self.model.measured, self.degree)
        highest = self.degree if self.polynomial is None else self.polynomial
        return [jet.only(lambda powers: sum(powers) <= highest) for jet in whole]

    @cached_property
    def u(self) -> list[Jet]:
        """The estimate with E[u] = h, by correcting what is left until nothing is."""
        found = self.h
        for _ in range(self.degree // 2 + 1):
            found = [u + (h - self.noise(u)) for u, h in zip(found, self.h, strict=True)]
        return found

    def noise(self, value: Jet) -> Jet:
        """Average over the measurement error."""
        return averaged(value, self.numbers(self.model.covariance))

    def prediction(self, value: Jet) -> Jet:
        """Average over the error of a prediction."""
        return averaged(value, self.numbers(self.model.prediction_covariance))

    def numbers(self, covariance: Covariance) -> list[list[Number]]:
        """A covariance at the point."""
        return [[self._number(entry) for entry in row] for row in covariance]

    def _number(self, entry: Expr) -> Number:
        return jets([entry], self.at, (), 0)[0].value if entry.free_symbols else evaluate(entry, {})


def at_point(jet: Jet, order: int | None = None) -> Number:
    """The sum over the powers of the errors, up to an order, where nothing is displaced."""
    return sum(
        (value for (*places, size), value in jet.terms.items() if not any(places) and (order is None or size <= order)),
        mpmath.mpf(0),
    )


def derivatives(series: Sequence[Jet], order: int, inputs: int, size: int = 0) -> Tensor[Number]:
    """All partial derivatives of an order at the point, shape [out, in, ...]; of terms of this size in the errors."""

    def entry(a: int, *places: int) -> Number:
        powers: Powers = (*(places.count(i) for i in range(inputs)), size)
        weight = 1
        for power in powers[:-1]:
            weight *= factorial(power)
        return series[a].terms.get(powers, mpmath.mpf(0)) * weight

    return Tensor.build((len(series), *[inputs] * order), entry)


def direct(row: str, model: Model, at: Mapping[Symbol, Number]) -> Tensor[Number] | None:
    """The quantity of a row at a point; None for a row that is no finite series."""
    word, _, last = row.rpartition(".")
    if row in EXPANSIONS:
        return EXPANSIONS[row](model, at)
    if word == "validity":
        return _validity(model, at, NEGLECTED[last])
    if word in ROWS and last in ORDERS:
        order = ORDERS[last]
        return defined(word, DirectSeries(model, at, order)).map(lambda jet: at_point(jet, order))
    if word in MEANS and last == "semidefinite":
        return _completed(word, DirectSeries(model, at, 4))
    return None


def _completed(word: str, of: DirectSeries) -> Tensor[Number]:
    """To fourth order, and the square of what the mean's slopes have in second order."""
    size, covariance = len(of.model.measured), of.numbers(of.model.covariance)
    means = [MEANS[word](of, h) for h in of.h]
    slopes = derivatives(means, 1, size, 2)
    cut_off = defined(word, of).map(lambda jet: at_point(jet, 4))

    def entry(a: int, b: int) -> Number:
        terms = (slopes[a, i] * covariance[i][j] * slopes[b, j] for i in range(size) for j in range(size))
        return cut_off[a, b] + sum(terms, mpmath.mpf(0))

    return Tensor.build(cut_off.shape, entry)


MEANS: dict[str, Callable[[DirectSeries, Jet], Jet]] = {
    "covariance.averaged": lambda of, h: of.noise(of.noise(h)),
    "unbiased.covariance": DirectSeries.noise,
    "posterior.covariance": DirectSeries.noise,
    "decorrelated.covariance": DirectSeries.prediction,
}


def _derivatives(order: int) -> Callable[[Model, Mapping[Symbol, Number]], Tensor[Number]]:
    return lambda model, at: derivatives(DirectSeries(model, at, order).h, order, len(model.measured))


def _moment(row: str, degree: int, polynomial: int) -> Callable[[Model, Mapping[Symbol, Number]], Tensor[Number]]:
    return lambda model, at: defined(row, DirectSeries(model, at, degree, polynomial)).map(at_point)


def _deviations(model: Model, at: Mapping[Symbol, Number]) -> list[Number]:
    """How far each coordinate of the linear part spreads."""
    covariance = defined("covariance.truth", DirectSeries(model, at, 2, 1)).map(at_point)
    return [mpmath.sqrt(covariance[a, a]) for a in range(len(model.outputs))]


def _std(model: Model, at: Mapping[Symbol, Number]) -> Tensor[Number]:
    return Tensor((len(model.outputs),), tuple(_deviations(model, at)))


def _std_of_position(model: Model, at: Mapping[Symbol, Number]) -> Tensor[Number]:
    deviations = _deviations(model, at)
    return Tensor((), (mpmath.norm(deviations) / mpmath.sqrt(len(deviations)),))


EXPANSIONS: dict[str, Callable[[Model, Mapping[Symbol, Number]], Tensor[Number]]] = {
    "map": _derivatives(0),
    "jacobian": _derivatives(1),
    "hessian": _derivatives(2),
    "bias.second_order": _moment("bias.truth", 2, 2),
    "covariance.linear": _moment("covariance.truth", 2, 1),
    "covariance.second_order": _moment("covariance.truth", 4, 2),
    "covariance.third_order": _moment("covariance.truth", 6, 3),
    "std.linear": _std,
    "std.position": _std_of_position,
}


def _validity(model: Model, at: Mapping[Symbol, Number], order: int) -> Tensor[Number]:
    """√E[(J⁻¹ g)ᵢ²]/σᵢ with g the part of the map of one degree in the errors."""
    series = DirectSeries(model, at, 2 * order)
    size = len(model.measured)
    slopes = derivatives(series.h, 1, size)
    inverse = mpmath.inverse(mpmath.matrix([[slopes[a, i] for i in range(size)] for a in range(size)]))
    parts = [h.only(lambda powers: sum(powers) == order) for h in series.h]

    def entry(i: int) -> Number:
        back = sum((parts[a].scaled(inverse[i, a]) for a in range(1, size)), parts[0].scaled(inverse[i, 0]))
        return mpmath.sqrt(at_point(series.noise(back * back))) / at[model.deviations[i]]

    return Tensor.build((size,), entry)
