"""The catalogue's quantities of the finite-sample filters of degree 0 to 3."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from radartrack.derive import symbolic as sp
from radartrack.derive.bibliography import cite
from radartrack.derive.finite_sample.least_squares_filter import (
    RATIO,
    C,
    FiniteSample,
    fewest_scans,
    j,
    k,
    scans,
    sigma_r,
    sigma_v,
    tau,
)
from radartrack.derive.finite_sample.orthogonal_polynomials import HIGHEST_DEGREE, GramForm
from radartrack.derive.finite_sample.range_rate_gain import Gain
from radartrack.derive.language.matrix import product, rows, transposed
from radartrack.derive.language.quantity import Conditioning, Quantity
from radartrack.derive.language.shared_symbols import T
from radartrack.derive.language.source import Source
from radartrack.derive.language.stable_form import StableForm
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.stable.shifted_count import counted_from
from radartrack.derive.symbolic import Expr
from radartrack.derive.units import METRE, ONE, SECOND, Unit

STATES = ("range", "range and range rate", "range and two derivatives", "range and three derivatives")
COMPONENTS = tuple(METRE / SECOND**n for n in range(HIGHEST_DEGREE + 1))
OBSERVED = {False: ("range", "range"), True: ("range_rate", "range and range rate")}


def source(where: str) -> Source:
    """An equation of the paper on filtering over a finite sample."""
    return cite("gorshkov", where)


def quantities() -> Iterator[Quantity]:
    """C, and every filter's matrices, weights and gain."""
    yield _ratio()
    for degree in range(HIGHEST_DEGREE + 1):
        filters = [FiniteSample(degree, with_rate) for with_rate in OBSERVED]
        for each in filters:
            yield from Family(each).quantities()
        yield from _gains(Gain(*filters))


@dataclass(frozen=True)
class Family:
    """The quantities of one filter."""

    filter: FiniteSample

    def quantities(self) -> Iterator[Quantity]:
        """All of them; nothing is derived yet."""
        yield from self._matrices()
        yield self._covariance("covariance", "at the newest scan", ())
        yield self._correlation()
        yield from self._weights("", "at the newest scan", ())
        yield self._covariance("at_lag.covariance", "tau scans after the newest one", (tau,))
        yield from self._weights("at_lag.", "tau scans after the newest one", (tau,))

    @property
    def form(self) -> GramForm:
        """How it is written for floating point."""
        return GramForm(self.filter)

    @property
    def scans(self) -> Variable:
        """The number of scans that determine the state for every C, 0 among them."""
        return scans(self.filter.size, fewest_scans(self.filter.degree, with_rate=self.filter.with_rate))

    @property
    def units(self) -> tuple[Unit, ...]:
        """The units of the state."""
        return COMPONENTS[: self.filter.size]

    @property
    def ratio(self) -> tuple[Variable, ...]:
        """C, where the range rate is measured."""
        return (C,) if self.filter.with_rate else ()

    @property
    def text(self) -> str:
        """What is estimated from what."""
        observed = OBSERVED[self.filter.with_rate][1]
        return f"{STATES[self.filter.degree]} from k scans of {observed}{self._fewer}"

    @property
    def _fewer(self) -> str:
        fewest = fewest_scans(self.filter.degree, with_rate=self.filter.with_rate)
        return f" (where C > 0, k from {fewest} on)" if fewest < self.filter.size else ""

    def _matrices(self) -> Iterator[Quantity]:
        inverse = tuple(unit**-1 for unit in self.units)
        observations = COMPONENTS[: 1 + self.filter.with_rate]
        per_observation = tuple(unit**-1 for unit in observations)
        yield self._quantity(
            "design", f"observations of scan j by {self.text}", "H_j", "(3)-(4)", (observations, inverse), (k, j, T),
            lambda: self.filter.design,
        )  # fmt: skip
        yield self._quantity(
            "precision", f"inverse variances of the observations of one scan, for {self.text}", "Q_theta", "(5)",
            (per_observation, per_observation), (sigma_r, T, C) if self.filter.with_rate else (sigma_r,),
            lambda: self.filter.precision,
        )  # fmt: skip
        yield self._quantity(
            "information", f"information matrix of {self.text}", "Q = sum_j H_j' Q_theta H_j", "(2), (6)",
            (inverse, inverse), (scans(1), T, sigma_r, *self.ratio),
            lambda: self.filter.information,
        )  # fmt: skip

    def _covariance(self, name: str, when: str, lag: tuple[Variable, ...]) -> Quantity:
        attribute = "lagged_covariance" if lag else "covariance"
        return self._quantity(
            name, f"error covariance of {self.text}, {when}", "R = (sum_j H_j' Q_theta H_j)^-1", "(2), (7)-(12)",
            (self.units, self.units), (self.scans, T, sigma_r, *self.ratio, *lag),
            lambda: getattr(self.filter, attribute),
            lambda: getattr(self.form, attribute),
        )  # fmt: skip

    def _correlation(self) -> Quantity:
        return self._quantity(
            "correlation", f"correlation of the errors of {self.text}, at the newest scan",
            "R_mn / sqrt(R_mm R_nn)", "(10)-(12)",
            ((ONE,) * self.filter.size,) * 2, (self.scans, *self.ratio),
            lambda: correlation(self.filter.covariance),
            lambda: counted_from(correlation(self.filter.covariance), k, self.filter.size),
        )  # fmt: skip

    def _weights(self, prefix: str, when: str, lag: tuple[Variable, ...]) -> Iterator[Quantity]:
        for kind in ("range", "rate")[: 1 + self.filter.with_rate]:
            yield self._weight(f"{prefix}{kind}_weights", kind, when, lag)

    def _weight(self, name: str, kind: str, when: str, lag: tuple[Variable, ...]) -> Quantity:
        attribute = f"{'lagged_' * bool(lag)}{kind}_weights"
        observation = METRE if kind == "range" else METRE / SECOND
        return self._quantity(
            name, f"weights of the {kind} of scan j in the estimate of {self.text}, {when}",
            "W_j = R H_j' Q_theta", "(13)-(20)",
            (tuple(unit / observation for unit in self.units),), (self.scans, j, T, *self.ratio, *lag),
            lambda: getattr(self.filter, attribute),
            lambda: getattr(self.form, attribute),
            lambda: weight_scale(self.filter, kind, lagged=bool(lag)),
            "the weights of this, the first and the last scan and the root mean square of all",
        )  # fmt: skip

    def _quantity(
        self,
        name: str,
        meaning: str,
        word: str,
        where: str,
        axes: tuple[tuple[Unit, ...], ...],
        symbols: tuple[Variable, ...],
        derivation: Callable[[], Tensor[Expr]],
        rewriting: Callable[[], StableForm] | None = None,
        scale: Callable[[], Tensor[Expr]] | None = None,
        measured_against: str = "",
    ) -> Quantity:
        return Quantity(
            name=f"finite_sample.degree{self.filter.degree}.{OBSERVED[self.filter.with_rate][0]}.{name}",
            meaning=meaning,
            axes=axes,
            symbols=symbols,
            conditioning=Conditioning.NONE,
            source=source(where),
            word=word,
            derivation=derivation,
            rewriting=rewriting or as_derived(derivation),
            scale=scale,
            measured_against=measured_against,
        )


def as_derived(derivation: Callable[[], Tensor[Expr]]) -> Callable[[], StableForm]:
    """A formula that is factored or of few terms serves in floating point as it is."""
    return lambda: StableForm({}, derivation())


def correlation(covariance: Tensor[Expr]) -> Tensor[Expr]:
    """Each entry over the root of the two variances; neither the period nor the size of the errors matters."""
    unit = covariance.map(lambda entry: entry.xreplace({T: sp.Integer(1), sigma_r: sp.Integer(1)}))
    return Tensor.build(
        unit.shape, lambda m, n: unit[m, n] / sp.sqrt(unit[m, m] * unit[n, n]) if m != n else sp.Integer(1)
    )


def weight_scale(of: FiniteSample, kind: str, *, lagged: bool) -> Tensor[Expr]:
    """What a weight is measured against: itself, that of the first and last scan, and the root mean square of all.

    A weight crosses zero on its way from scan to scan. What counts is its error beside the other weights: the
    sum of their squares is an entry of W Wᵀ = R (H Q_θ Hᵀ) R Q_θ, a closed form.
    """
    own = getattr(of, f"{'lagged_' * lagged}{kind}_weights")
    is_rate = kind == "rate"
    information = of.information_of_rates if is_rate else of.information_of_ranges
    precision = of.weight_of_rate * T**2 if is_rate else sp.Integer(1)
    covariance, transition = rows(of.covariance), rows(of.transition)
    squares = product(covariance, product(rows(information), covariance))
    if lagged:
        squares = product(transition, product(squares, transposed(transition)))
    unit = {sigma_r: sp.Integer(1)}
    ends = [own.map(lambda entry, at=at: entry.xreplace({j: at})) for at in (j, sp.Integer(1), k)]
    return Tensor.build(
        (of.size,),
        lambda m: sp.sqrt(squares[m][m].xreplace(unit) * precision / k + sp.Add(*(some[m,] ** 2 for some in ends))),
    )


def _ratio() -> Quantity:
    return Quantity(
        name="finite_sample.C",
        meaning="weight of the range rate beside the range",
        axes=(),
        symbols=(sigma_r, sigma_v, T),
        conditioning=Conditioning.NONE,
        source=source("(6)"),
        word="C = sigma_r^2/(T^2 sigma_v^2)",
        derivation=lambda: Tensor((), (RATIO,)),
    )


def _gains(gain: Gain) -> Iterator[Quantity]:
    degree, size = gain.without.degree, gain.without.size
    state = STATES[degree]
    counts = scans(size)
    yield Quantity(
        name=f"finite_sample.degree{degree}.gain",
        meaning=f"part of the standard deviations of {state} that the range rate removes, at the newest scan",
        axes=((ONE,) * size,),
        symbols=(counts, C),
        conditioning=Conditioning.NONE,
        source=source("(22)"),
        word="K_x = 1 - sqrt(R_xx with range rate / R_xx without)",
        derivation=lambda: gain.gain,
        rewriting=lambda: counted_from(gain.gain, k, size),
        scale=lambda: gain.gain,
        measured_against="itself",
    )
    yield Quantity(
        name=f"finite_sample.degree{degree}.range_gain_of_perfect_rate",
        meaning=f"part of the standard deviation of the range, of {state}, that errorless range rates would remove",
        axes=(),
        symbols=(counts,),
        conditioning=Conditioning.NONE,
        source=source("(22)"),
        word="limit of K_r for C to infinity",
        derivation=lambda: Tensor((), (gain.range_gain_of_perfect_rate,)),
        rewriting=as_derived(lambda: Tensor((), (gain.range_gain_of_perfect_rate,))),
    )
