"""The least-squares polynomial filter over k scans, from range or from range and range rate.

The newest scan is number k. The state is the value and the first `degree` derivatives of the polynomial at a
time that lies τ scans after the newest one, so with H_j its map to what scan j measures and Q_θ the inverse
variances,

    Q = Σ_j H_jᵀ Q_θ H_j,    R = Q⁻¹,    W_j = R H_jᵀ Q_θ.

Everything is exact for a symbolic number of scans: the sums are closed, and R is a matrix of adjoints over
determinants.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from math import factorial

from radartrack.derive import symbolic as sp
from radartrack.derive.finite_sample.centred_filter import CentredFilter
from radartrack.derive.finite_sample.power_sums import summed
from radartrack.derive.language.shared_symbols import T
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr, PolyElement, PolyRing, Symbol
from radartrack.derive.units import METRE, METRE_PER_SECOND, ONE

MOST_SCANS = 1e6

sigma_r = Variable("sigma_r", "standard deviation of the error of the range", METRE, 1e-3, 1e4)
sigma_v = Variable("sigma_v", "standard deviation of the error of the range rate", METRE_PER_SECOND, 1e-4, 1e4)
C = Variable("C", "sigma_r^2/(T^2 sigma_v^2), the weight of the range rate", ONE, 0.0, 1e12)
tau = Variable("tau", "scans from the newest one to the time of the estimate, less than 0 to smooth", ONE, -1e6, 1e6)


def scans(fewest: int, least: int | None = None) -> Variable:
    """The number of scans k, from the fewest on; the symbol is the same for every domain.

    Args:
        fewest: the lower end of the domain.
        least: scans that determine something, where they are fewer: with range rates in some cases.
    """
    least = fewest if least is None else least
    return Variable("k", "number of scans", ONE, float(fewest), MOST_SCANS, whole=True, least=least)


k = scans(1)
j = Variable(
    "j",
    "number of the scan that is weighted, 1 the oldest, k the newest",
    ONE,
    1.0,
    MOST_SCANS,
    whole=True,
    at_most=k,
)

RING = PolyRing([k, C, j, tau], sp.QQ)
NEWEST = sp.Integer(0)
RATIO = sigma_r**2 / (T**2 * sigma_v**2)


@dataclass(frozen=True)
class FiniteSample:
    """The filter of one degree and one set of observations.

    Attributes:
        degree: of the polynomial; the state has degree + 1 components.
        with_rate: whether the range rate is measured beside the range.
    """

    degree: int
    with_rate: bool

    @property
    def size(self) -> int:
        """The number of components of the state."""
        return self.degree + 1

    @property
    def weight_of_rate(self) -> Expr:
        """C, or 0 without the range rate."""
        return C if self.with_rate else sp.Integer(0)

    def range_row(self) -> list[Expr]:
        """The range at scan j by the components of the state at the newest scan."""
        return [((j - k) * T) ** n / sp.Integer(factorial(n)) for n in range(self.size)]

    def rate_row(self) -> list[Expr]:
        """The range rate at scan j by the components of the state at the newest scan."""
        return [sp.Integer(0), *self.range_row()[:-1]]

    @cached_property
    def design(self) -> Tensor[Expr]:
        """H_j, one row an observation."""
        rows = [self.range_row(), self.rate_row()][: 1 + self.with_rate]
        return Tensor.build((len(rows), self.size), lambda a, n: rows[a][n])

    @cached_property
    def precision(self) -> Tensor[Expr]:
        """Q_θ of one scan: the inverse variances of its observations."""
        inverse = [sigma_r**-2, C * T**2 / sigma_r**2]
        rows = 1 + self.with_rate
        return Tensor.build((rows, rows), lambda a, b: inverse[a] if a == b else sp.Integer(0))

    @cached_property
    def information(self) -> Tensor[Expr]:
        """Q = Σ H_jᵀ Q_θ H_j."""
        ranges, rates = self.information_of_ranges, self.information_of_rates
        return Tensor.build(ranges.shape, lambda m, n: sp.factor(ranges[m, n] + rates[m, n]))

    @cached_property
    def information_of_ranges(self) -> Tensor[Expr]:
        """What the ranges add to Q."""
        return _gram(self.range_row(), sigma_r**-2)

    @cached_property
    def information_of_rates(self) -> Tensor[Expr]:
        """What the range rates add to Q; nothing where they are not measured."""
        return _gram(self.rate_row(), self.weight_of_rate * T**2 / sigma_r**2)

    @cached_property
    def covariance(self) -> Tensor[Expr]:
        """R = Q⁻¹ at the newest scan: the adjoint over the determinant, as rational functions of k and C."""
        return self._covariance(NEWEST)

    @cached_property
    def range_weights(self) -> Tensor[Expr]:
        """What the range of scan j adds to each component, for one metre."""
        return self._weights(NEWEST, rates=False)

    @cached_property
    def rate_weights(self) -> Tensor[Expr]:
        """What the range rate of scan j adds to each component, for one metre per second."""
        return self._weights(NEWEST, rates=True)

    @cached_property
    def transition(self) -> Tensor[Expr]:
        """The state τ scans after the newest one by the state at the newest one."""
        return Tensor.build(
            (self.size, self.size),
            lambda m, n: (tau * T) ** (n - m) / sp.Integer(factorial(n - m)) if n >= m else sp.Integer(0),
        )

    @cached_property
    def lagged_covariance(self) -> Tensor[Expr]:
        """The covariance of the estimate τ scans after the newest one."""
        return self._covariance(tau)

    @cached_property
    def lagged_range_weights(self) -> Tensor[Expr]:
        """The weights of the range for the estimate τ scans after the newest one."""
        return self._weights(tau, rates=False)

    @cached_property
    def lagged_rate_weights(self) -> Tensor[Expr]:
        """The weights of the range rate for the estimate τ scans after the newest one."""
        return self._weights(tau, rates=True)

    # The period and the size of the errors only scale the state: the centred filter is for T = 1 and σ_r = 1.

    @cached_property
    def _centred(self) -> CentredFilter:
        return CentredFilter(RING, k, self.size, RING.from_expr(self.weight_of_rate))

    def _covariance(self, lag: Expr) -> Tensor[Expr]:
        found = self._centred.covariance(_after_middle(k + lag))
        return Tensor.build(found.shape, lambda m, n: found[m, n] * sigma_r**2 / T ** (m + n))

    def _weights(self, lag: Expr, *, rates: bool) -> Tensor[Expr]:
        found = self._centred.weights(_after_middle(k + lag), _after_middle(j), int(rates))
        factor = self.weight_of_rate * T if rates else sp.Integer(1)
        return Tensor.build(found.shape, lambda m: found.entries[m] * factor / T**m)


def _after_middle(scan: Expr) -> PolyElement:
    """The time of a scan, in scans after the middle of the sample."""
    return RING.from_expr(sp.expand(scan - (k + 1) / 2))


def fewest_scans(degree: int, *, with_rate: bool) -> int:
    """The fewest scans that determine a polynomial: k distinct values give k data, values and slopes 2k (Hermite)."""
    return (degree + 2) // 2 if with_rate else degree + 1


def highest_degree(count: int, *, with_rate: bool) -> int:
    """The highest degree that `count` scans determine."""
    return 2 * count - 1 if with_rate else count - 1


def _gram(row: list[Expr], precision: Expr) -> Tensor[Expr]:
    """Σ_j rowᵀ row × precision, over all scans; i = k − j counts them from the newest backwards."""
    back = Symbol("i", integer=True)
    backwards = [entry.xreplace({j: k - back}) for entry in row]
    return Tensor.build(
        (len(row), len(row)), lambda m, n: sp.factor(summed(backwards[m] * backwards[n], back, k) * precision)
    )
