"""The finite-sample filter over orthogonal polynomials, a form in which nothing cancels.

The scans lie evenly about their middle. Measure time in scans from there, s, and weigh a slope by C:

    ⟨p, q⟩ = Σ_j p(s_j) q(s_j) + C Σ_j p′(s_j) q′(s_j).

With polynomials p_l that are orthogonal under this product,

    R_mn = σ_r² / T^(m+n) Σ_l p_l^(m) p_l^(n) / ⟨p_l, p_l⟩,
    w_m(j) = 1 / T^m Σ_l p_l^(m) p_l(s_j) / ⟨p_l, p_l⟩,

the derivatives taken where the estimate is wanted. The variances are sums of squares, and by Cauchy and
Schwarz no covariance is less accurate than they are. The polynomials are those of Gram, except that C shifts
the third one: its coefficients lie between those for range alone and those for range rate alone, as the
information on the slope is shared by the two. At the ends of the sample they are counted from the ends, through
`reach`, the product of the distances to the first and the last scan; so they keep their accuracy where few scans barely
determine the state. Elsewhere powers of s cancel less; at a lag both are taken, weighed by the nearness to an end.

This table is short because it is written by hand. It is proved equal to the normal equations wherever it is
used.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from radartrack.derive import symbolic as sp
from radartrack.derive.finite_sample.least_squares_filter import C, FiniteSample, j, k, sigma_r, tau
from radartrack.derive.language.shared_symbols import T
from radartrack.derive.language.stable_form import StableForm
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.symbolic import Expr, Symbol

HIGHEST_DEGREE = 3
Definitions = dict[Symbol, Expr]


def _name(name: str) -> Symbol:
    return Symbol(name, real=True)


SPAN = _name("span")
BEND = _name("bend")
MIDDLE = _name("middle")
RANGE_SHARE = _name("range_share")
RATE_SHARE = _name("rate_share")
POSITION = _name("position")
REACH = _name("reach")
NEARNESS = _name("nearness")
SCAN_POSITION = _name("scan_position")
SCAN_REACH = _name("scan_reach")
PER_NORM = tuple(map(_name, ("per_constant", "per_slope", "per_curvature", "per_cubic")))


@dataclass(frozen=True)
class Place:
    """Where a polynomial is evaluated.

    Attributes:
        position: scans after the middle of the sample.
        reach: scans after the first times scans before the last.
    """

    position: Expr
    reach: Expr


NEWEST = Place(MIDDLE, sp.Integer(0))
LAGGED = Place(POSITION, REACH)
AT_SCAN = Place(SCAN_POSITION, SCAN_REACH)


def _between(at_ends: Expr, elsewhere: Expr) -> Expr:
    """Two ways to write one thing, the first near the ends of the sample."""
    return NEARNESS * at_ends + (1 - NEARNESS) * elsewhere


@dataclass(frozen=True)
class GramForm:
    """Rewrites the covariance and the weights of a filter of degree 3 at most."""

    filter: FiniteSample

    @property
    def covariance(self) -> StableForm:
        """R at the newest scan."""
        return self._covariance(NEWEST)

    @property
    def lagged_covariance(self) -> StableForm:
        """R at τ scans after the newest one."""
        return self._covariance(LAGGED)

    @property
    def range_weights(self) -> StableForm:
        """The weights of the range for the estimate at the newest scan."""
        return self._weights(NEWEST, rates=False)

    @property
    def rate_weights(self) -> StableForm:
        """The weights of the range rate for the estimate at the newest scan."""
        return self._weights(NEWEST, rates=True)

    @property
    def lagged_range_weights(self) -> StableForm:
        """The weights of the range for the estimate τ scans after the newest one."""
        return self._weights(LAGGED, rates=False)

    @property
    def lagged_rate_weights(self) -> StableForm:
        """The weights of the range rate for the estimate τ scans after the newest one."""
        return self._weights(LAGGED, rates=True)

    def _covariance(self, place: Place) -> StableForm:
        table = self._table(place)
        size = self.filter.size

        def entry(m: int, n: int) -> Expr:
            terms = (table[p][m] * table[p][n] * PER_NORM[p] for p in range(max(m, n), size))
            return sigma_r**2 * sp.Add(*terms) / T ** (m + n)

        return self._form(Tensor.build((size, size), entry))

    def _weights(self, place: Place, *, rates: bool) -> StableForm:
        table, scan = self._table(place), self._table(AT_SCAN)
        size = self.filter.size
        factor = C * T if rates else sp.Integer(1)

        def entry(m: int) -> Expr:
            return factor * sp.Add(*(table[p][m] * scan[p][rates] * PER_NORM[p] for p in range(m, size))) / T**m

        return self._form(Tensor.build((size,), entry))

    def _form(self, entries: Tensor[Expr]) -> StableForm:
        return StableForm(self._definitions, entries, frozenset({NEARNESS})).only(entries)

    def _table(self, place: Place) -> list[list[Expr]]:
        """One row a polynomial: its value and its derivatives."""
        s, zero, one = place.position, sp.Integer(0), sp.Integer(1)
        value, slope = self._cubic_at_ends
        square = (k - 1) * (k - 2) / 6 - place.reach
        steepness = slope - 3 * place.reach
        if place == LAGGED:
            square = _between(square, s**2 - SPAN / 12)
            steepness = _between(steepness, 3 * s**2 - self._shared((3 * k**2 - 7) / 20, SPAN / 4))
        table: list[list[Expr]] = [
            [one, zero, zero, zero],
            [s, one, zero, zero],
            [square, 2 * s, sp.Integer(2), zero],
            [s * (value - place.reach), steepness, 6 * s, sp.Integer(6)],
        ]
        return table[: self.filter.size]

    @property
    def _cubic_at_ends(self) -> tuple[Expr, Expr]:
        """The cubic over its argument, and its slope, at the ends of the sample."""
        value = self._shared((k - 2) * (k - 3) / 10, -(k - 1) / 2)
        slope = self._shared((6 * (k - 1) * (k - 2) + 3 * k - 1) / 10, (k - 1) * (k - 2) / 2)
        return value, slope

    def _shared(self, by_range: Expr, by_rate: Expr) -> Expr:
        """Between the value for range alone and that for range rate alone."""
        return RANGE_SHARE * by_range + RATE_SHARE * by_rate if self.filter.with_rate else by_range

    @cached_property
    def _definitions(self) -> Definitions:
        weight = self.filter.weight_of_rate
        cubic = BEND * (k - 3) * (k + 3) / 2800
        if self.filter.with_rate:
            cubic += weight * BEND / 20 + (k**2 + 1) ** 2 * RATE_SHARE / 1200
        return {
            SPAN: (k - 1) * (k + 1),
            BEND: (k - 2) * (k + 2),
            RANGE_SHARE: SPAN / (SPAN + 12 * weight),
            RATE_SHARE: 12 * weight / (SPAN + 12 * weight),
            MIDDLE: (k - 1) / 2,
            POSITION: MIDDLE + tau,
            REACH: -tau * (k - 1 + tau),
            NEARNESS: MIDDLE**4 / (MIDDLE**4 + 4 * REACH**2),
            SCAN_POSITION: j - (k + 1) / 2,
            SCAN_REACH: (j - 1) * (k - j),
            PER_NORM[0]: 1 / k,
            PER_NORM[1]: 12 / (k * (SPAN + 12 * weight)),
            PER_NORM[2]: 180 / (k * SPAN * (BEND + 60 * weight)),
            PER_NORM[3]: 1 / (k * SPAN * cubic),
        }
