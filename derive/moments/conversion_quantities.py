"""All quantities of a measurement model: its Taylor expansion and the table of words."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache, cached_property
from math import factorial
from typing import Any

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.exponential_polynomial import ExponentialPolynomial, NotExponentialPolynomial
from radartrack.derive.bibliography import cite
from radartrack.derive.language.model import Model
from radartrack.derive.language.quantity import Conditioning, Quantity
from radartrack.derive.language.source import Source
from radartrack.derive.language.stable_form import StableForm
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.moments import debiased_conversion, taylor
from radartrack.derive.moments.closed_form import Closed
from radartrack.derive.moments.truncated_series import Truncated
from radartrack.derive.moments.validity_of_linearisation import NEGLECTED, is_square, validity, validity_form
from radartrack.derive.stable.rewriting import general_form
from radartrack.derive.symbolic import Expr
from radartrack.derive.units import ONE, Unit

Axes = tuple[tuple[Unit, ...], ...]
Word = Callable[[Any], Tensor[Any]]
ORDERS = {2: "second_order", 4: "fourth_order"}


@dataclass(frozen=True, eq=False)
class Conversion:
    """A model with what its quantities share."""

    model: Model

    @cached_property
    def closed(self) -> Closed | None:
        """Map and expectations in closed form; None for a map that is not polynomial × trigonometric."""
        try:
            return Closed(self.model)
        except NotExponentialPolynomial:
            return None

    @cache  # noqa: B019 - a conversion lives as long as its quantities
    def truncated(self, order: int) -> Truncated:
        """Map and expectations to an even order in the deviations."""
        return Truncated(self.model, order)

    @property
    def inward(self) -> tuple[Unit, ...]:
        """The units of a derivative by each measured quantity."""
        return tuple(variable.unit**-1 for variable in self.model.measured)

    @property
    def arguments(self) -> tuple[Variable, ...]:
        """What the map depends on."""
        return self.model.arguments

    @property
    def noisy(self) -> tuple[Variable, ...]:
        """What an expectation over the measurement error depends on."""
        return (*self.model.arguments, *self.model.noise_symbols)

    @property
    def predicted(self) -> tuple[Variable, ...]:
        """What an average over a prediction depends on."""
        return (*self.noisy, *self.model.prediction_symbols)

    @cached_property
    def sums_of_variances(self) -> Tensor[Expr]:
        """For each variance those of all coordinates of its unit, to first order and of independent errors."""
        model = self.model
        slopes = taylor.jacobian(model.map, model.measured)

        def total(unit: Unit) -> Expr:
            alike = [a for a, other in enumerate(model.units) if other == unit]
            squares = [sp.Add(*(slopes[a, k] ** 2 for a in alike)) for k in range(len(model.measured))]
            lengths = general_form(Tensor((len(squares),), tuple(squares))).expanded().entries
            return sp.Add(*(sigma**2 * of for sigma, of in zip(model.deviations, lengths, strict=True)))

        sums = {unit: total(unit) for unit in dict.fromkeys(model.units)}
        roots = [sp.sqrt(sums[unit]) for unit in model.units]
        return Tensor.build((len(roots), len(roots)), lambda a, b: roots[a] * roots[b])

    def taylor(self, expansion: Callable[..., Tensor[Expr]]) -> Tensor[Expr]:
        """A moment of the Taylor polynomial."""
        return expansion(self.model.map, self.model.measured, self.model.covariance)

    def exact(self, word: Word) -> Tensor[Expr]:
        """A word in closed form."""
        if self.closed is None:
            raise NotExponentialPolynomial(f"the map of {self.model.name} has no closed forms; ask for an order")
        return word(self.closed).map_distinct(ExponentialPolynomial.expression)

    def to_order(self, word: Word, order: int) -> Tensor[Expr]:
        """A word to an even order in the deviations."""
        calculus = self.truncated(order)
        return word(calculus).map_distinct(calculus.total)

    def completed(self, word: Word, mean: Callable[[Truncated, Any], Any]) -> Tensor[Expr]:
        """A covariance to fourth order, and what makes it a sum of squares."""
        calculus = self.truncated(4)
        means, values = list(calculus.map.map(lambda h: mean(calculus, h))), word(calculus)
        size = len(means)
        upper = {
            (a, b): calculus.completed(values[a, b], means[a], means[b]) for a in range(size) for b in range(a, size)
        }
        return Tensor.build((size, size), lambda a, b: upper[min(a, b), max(a, b)])


@dataclass(frozen=True)
class Row:
    """One kind of quantity that every model has."""

    name: str
    meaning: str
    word: str
    conditioning: Conditioning
    source: Source
    axes: Callable[[Conversion], Axes]
    symbols: Callable[[Conversion], tuple[Variable, ...]]
    derive: Callable[[Any], Tensor[Any]]


Derivation = Callable[[Conversion], Tensor[Expr]]


def _vector(conversion: Conversion) -> Axes:
    return (conversion.model.units,)


def _square(conversion: Conversion) -> Axes:
    return (conversion.model.units, conversion.model.units)


TAYLOR = cite("prosov", "(6)-(7)")
BAR_SHALOM = cite("barshalom1995")
LERRO = cite("lerro1993")
MO = cite("mo1998")
DUAN = cite("duan2004", "modified unbiased")
BORDONARO = cite("bordonaro2014", "decorrelated", cite("mo1998", "R_m where Kp = K, R_t where Kp = 0"))

# fmt: off - a table reads best with few lines a row
EXPANSION = (
    Row(
        "map",
        "map from the measured quantities to coordinates",
        "h",
        Conditioning.NONE,
        cite("prosov", "(1)"),
        _vector,
        lambda c: c.arguments,
        lambda c: c.model.map,
    ),
    Row(
        "jacobian",
        "first derivatives of the map, [out, in]",
        "dh/dtheta",
        Conditioning.NONE,
        TAYLOR,
        lambda c: (c.model.units, c.inward),
        lambda c: c.arguments,
        lambda c: taylor.jacobian(c.model.map, c.model.measured),
    ),
    Row(
        "hessian",
        "second derivatives of the map, [out, in, in]",
        "d2h/dtheta2",
        Conditioning.NONE,
        TAYLOR,
        lambda c: (c.model.units, c.inward, c.inward),
        lambda c: c.arguments,
        lambda c: taylor.hessian(c.model.map, c.model.measured),
    ),
    Row(
        "bias.second_order",
        "bias of the plain conversion to second order",
        "L h",
        Conditioning.TRUTH,
        cite("prosov", "(7)"),
        _vector,
        lambda c: c.noisy,
        lambda c: c.taylor(taylor.second_order_bias),
    ),
    Row(
        "covariance.linear",
        "covariance of the linearised conversion",
        "J K J'",
        Conditioning.TRUTH,
        cite("prosov", "(9)", cite("gao2020", "(1)")),
        _square,
        lambda c: c.noisy,
        lambda c: c.taylor(taylor.linear_covariance),
    ),
    Row(
        "covariance.second_order",
        "covariance of the conversion's quadratic Taylor polynomial",
        "J K J' + tr(G_a K G_b K)/2",
        Conditioning.TRUTH,
        BAR_SHALOM,
        _square,
        lambda c: c.noisy,
        lambda c: c.taylor(taylor.second_order_covariance),
    ),
)
# fmt: on

CUBIC = Row(
    "covariance.third_order",
    "covariance of the conversion's cubic Taylor polynomial",
    "E[p p'] - E[p] E[p]', p = h + (w.d) h + (w.d)^2 h/2 + (w.d)^3 h/6",
    Conditioning.TRUTH,
    BAR_SHALOM,
    _square,
    lambda c: c.noisy,
    lambda c: c.taylor(taylor.third_order_covariance),
)

# fmt: off - a table reads best with few lines a row
WORDS = (
    Row(
        "bias.truth",
        "exact bias of the plain conversion h(z)",
        "(e^L - 1) h",
        Conditioning.TRUTH,
        LERRO,
        _vector,
        lambda c: c.noisy,
        debiased_conversion.bias_truth,
    ),
    Row(
        "bias.averaged",
        "exact bias of the plain conversion, averaged over the truth",
        "(e^2L - e^L) h",
        Conditioning.MEASUREMENT,
        LERRO,
        _vector,
        lambda c: c.noisy,
        debiased_conversion.bias_averaged,
    ),
    Row(
        "covariance.truth",
        "exact covariance of the plain conversion h(z)",
        "C = e^L(h h') - (e^L h)(e^L h)'",
        Conditioning.TRUTH,
        LERRO,
        _square,
        lambda c: c.noisy,
        debiased_conversion.covariance_truth,
    ),
    Row(
        "covariance.averaged",
        "exact covariance of the plain conversion, averaged over the truth",
        "e^L C",
        Conditioning.MEASUREMENT,
        cite("lerro1993", "", cite("prosov", "(11)")),
        _square,
        lambda c: c.noisy,
        debiased_conversion.covariance_averaged,
    ),
    Row(
        "unbiased.estimate",
        "exactly unbiased estimate of the position",
        "u = e^-L h",
        Conditioning.MEASUREMENT,
        MO,
        _vector,
        lambda c: c.noisy,
        debiased_conversion.unbiased_estimate,
    ),
    Row(
        "unbiased.covariance",
        "error covariance of the unbiased estimate u",
        "u u' - u (e^L h)' - (e^L h) u' + e^L(h h')",
        Conditioning.MEASUREMENT,
        MO,
        _square,
        lambda c: c.noisy,
        debiased_conversion.unbiased_covariance,
    ),
    Row(
        "posterior.estimate",
        "posterior mean of the position under a flat prior",
        "e^L h",
        Conditioning.MEASUREMENT,
        DUAN,
        _vector,
        lambda c: c.noisy,
        debiased_conversion.posterior_estimate,
    ),
    Row(
        "posterior.covariance",
        "posterior covariance of the position under a flat prior",
        "e^L(h h') - (e^L h)(e^L h)'",
        Conditioning.MEASUREMENT,
        DUAN,
        _square,
        lambda c: c.noisy,
        debiased_conversion.covariance_truth,
    ),
    Row(
        "decorrelated.covariance",
        "covariance of the unbiased estimate u, averaged over a prediction",
        "e^Lp [e^L(u u') - h h']",
        Conditioning.PREDICTION,
        BORDONARO,
        _square,
        lambda c: c.predicted,
        debiased_conversion.decorrelated_covariance,
    ),
)
# fmt: on


# Averages of the covariance of u that papers print; of models with closed forms, where they differ from its series.
PRINTED = (
    Row(
        "unbiased.covariance.truth",
        "covariance of the unbiased estimate u about the true position, R_t of Mo et al.",
        "e^L(u u') - h h'",
        Conditioning.TRUTH,
        cite("mo1998", "R_t"),
        _square,
        lambda c: c.noisy,
        debiased_conversion.unbiased_covariance_truth,
    ),
    Row(
        "unbiased.covariance.averaged",
        "covariance of the unbiased estimate u, averaged over the truth, R_m of Mo et al.",
        "e^L [e^L(u u') - h h']",
        Conditioning.MEASUREMENT,
        cite("mo1998", "R_m"),
        _square,
        lambda c: c.noisy,
        debiased_conversion.unbiased_covariance_averaged,
    ),
)


@dataclass(frozen=True)
class Square:
    """The mean whose derivatives are in a covariance, and its part of second order in words."""

    mean: Callable[[Truncated, Any], Any]
    word: str


SQUARES = {
    "covariance.averaged": Square(lambda calculus, h: calculus.expectation(h, 2), "2 L h"),
    "unbiased.covariance": Square(Truncated.expectation, "L h"),
    "posterior.covariance": Square(Truncated.expectation, "L h"),
    "decorrelated.covariance": Square(Truncated.prediction, "Lp h"),
}


def quantities_of(model: Model) -> list[Quantity]:
    """Every quantity of a model, the same ones each time; nothing is derived before it is asked for.

    A model without errors has its map and the derivatives of that.
    A map without closed forms has the second- and fourth-order series of each word in their place, and the latter
    completed to a sum of squares for each covariance of a conversion.
    """
    return list(_quantities(model))


@cache
def _quantities(model: Model) -> tuple[Quantity, ...]:
    shared = Conversion(model)
    if not model.deviations:
        return tuple(_quantity(shared, row, row.derive) for row in EXPANSION if row.conditioning is Conditioning.NONE)
    expansion = [_quantity(shared, row, row.derive) for row in EXPANSION]
    expansion += _deviations(shared)
    if is_square(model):
        expansion += [_validity(shared, formulas) for formulas in NEGLECTED]
    if shared.closed is not None:
        cubic = _quantity(shared, CUBIC, CUBIC.derive)
        return (*expansion, cubic, *(_quantity(shared, row, _exactly(row)) for row in (*WORDS, *PRINTED)))
    series = [_to_order(shared, row, order) for row in WORDS for order in ORDERS]
    return (*expansion, *series, *(_semidefinite(shared, row) for row in WORDS if row.name in SQUARES))


def word_to_order(model: Model, name: str, order: int) -> Tensor[Expr]:
    """A word such as `bias.truth` or `covariance.averaged` to any even order in the deviations.

    Raises:
        ValueError: for an unknown word, or an order that is not even and positive.
    """
    known = {row.name: row for row in WORDS}
    if name not in known:
        raise ValueError(f"name must be one of {', '.join(known)}; given {name!r}")
    return Conversion(model).to_order(known[name].derive, order)


def _deviations(shared: Conversion) -> list[Quantity]:
    """Standard deviations of the linearised conversion: of each coordinate, and of the position as a whole."""
    units = shared.model.units
    each = Quantity(
        name=f"{shared.model.name}.std.linear",
        meaning="standard deviation of each coordinate of the linearised conversion",
        axes=(units,),
        symbols=shared.noisy,
        conditioning=Conditioning.TRUTH,
        source=cite("gao2020", "(1)"),
        word="sqrt((J K J')_aa)",
        scaled_by=shared.model.scaled_by,
        derivation=lambda: _coordinate_deviations(shared).expanded(),
        rewriting=lambda: _coordinate_deviations(shared),
        model=shared.model,
    )
    position = Quantity(
        name=f"{shared.model.name}.std.position",
        meaning="root mean square of the coordinates' standard deviations, linearised",
        axes=(),
        common_unit=units[0],
        symbols=shared.noisy,
        conditioning=Conditioning.TRUTH,
        source=cite("gao2020", "(2)"),
        word="sqrt(tr(J K J')/n)",
        scaled_by=shared.model.scaled_by,
        derivation=lambda: _position_deviation(shared).expanded(),
        rewriting=lambda: _position_deviation(shared),
        model=shared.model,
    )
    return [each, position] if len(set(units)) == 1 else [each]


def _variances(shared: Conversion) -> StableForm:
    covariance = shared.taylor(taylor.linear_covariance)
    return general_form(Tensor((len(shared.model.units),), tuple(row[i,] for i, row in enumerate(covariance.parts()))))


def _coordinate_deviations(shared: Conversion) -> StableForm:
    variances = _variances(shared)
    return variances.only(variances.entries.map(sp.sqrt))


def _position_deviation(shared: Conversion) -> StableForm:
    variances = _variances(shared)
    mean = sp.Add(*variances.entries) / len(variances.entries.entries)
    return variances.only(Tensor((), (sp.sqrt(mean),)))


def _validity(shared: Conversion, formulas: str) -> Quantity:
    model = shared.model
    return Quantity(
        name=f"{model.name}.validity.{formulas}",
        meaning=(
            f"leading term that the {formulas.replace('_', '-')} formulas neglect, root mean square, over the linear "
            "standard deviation, one a measured quantity"
        ),
        axes=((ONE,) * len(model.measured),),
        symbols=shared.noisy,
        conditioning=Conditioning.TRUTH,
        source=cite("prosov", "the question of validity"),
        word=f"sqrt(E[(J^-1 (w.d)^{NEGLECTED[formulas]} h)_i^2])/({factorial(NEGLECTED[formulas])} sigma_i)",
        scaled_by=model.scaled_by,
        derivation=lambda: validity(model, formulas),
        rewriting=lambda: validity_form(model, formulas),
        model=model,
    )


def _exactly(row: Row) -> Derivation:
    return lambda shared: shared.exact(row.derive)


def _to_order(shared: Conversion, row: Row, order: int) -> Quantity:
    named = replace(
        row,
        name=f"{row.name}.{ORDERS[order]}",
        meaning=f"{row.meaning.replace('exact ', '').replace('exactly ', '')}, to {ORDERS[order].replace('_', ' ')}",
        word=f"{row.word} to sigma^{order}",
    )
    return _quantity(shared, named, lambda conversion: conversion.to_order(row.derive, order))


def _semidefinite(shared: Conversion, row: Row) -> Quantity:
    named = replace(
        row,
        name=f"{row.name}.semidefinite",
        meaning=f"{row.meaning.replace('exact ', '')}, to fourth order, completed to a sum of squares",
        word=f"{row.word} to sigma^4 + dg K dg', g = {SQUARES[row.name].word}",
    )
    return _quantity(shared, named, lambda conversion: conversion.completed(row.derive, SQUARES[row.name].mean))


def _quantity(shared: Conversion, row: Row, derive: Derivation) -> Quantity:
    vanishes = shared.model.variances_vanish and row.axes is _square
    return Quantity(
        name=f"{shared.model.name}.{row.name}",
        meaning=row.meaning,
        axes=row.axes(shared),
        symbols=row.symbols(shared),
        conditioning=row.conditioning,
        source=row.source if row.name != "map" else shared.model.source,
        word=row.word,
        derivation=lambda: derive(shared),
        scale=(lambda: shared.sums_of_variances) if vanishes else None,
        measured_against="the sum of the variances to first order of independent errors" if vanishes else "",
        model=shared.model,
        scaled_by=shared.model.scaled_by,
    )
