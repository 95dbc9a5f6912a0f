"""What the range rate adds to a finite-sample filter: the gain of each component, and its limits.

The gain of a component is the part of its standard deviation that the range rate removes, K = 1 − √ρ with ρ
the quotient of the variances with and without it. It is derived as (1 − ρ)/(1 + √ρ), which does not cancel
where C is small.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from radartrack.derive import symbolic as sp
from radartrack.derive.finite_sample.least_squares_filter import C, FiniteSample, k
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.symbolic import Expr, Symbol


@dataclass(frozen=True)
class Gain:
    """The comparison of two filters of one degree, without and with the range rate."""

    without: FiniteSample
    with_rate: FiniteSample

    @cached_property
    def variance_ratios(self) -> Tensor[Expr]:
        """ρ of each component: the variance with the range rate over the variance without."""
        with_rate, without = self.with_rate.covariance, self.without.covariance
        return Tensor.build((self.without.size,), lambda n: sp.factor(with_rate[n, n] / without[n, n]))

    @cached_property
    def gain(self) -> Tensor[Expr]:
        """K_x(k) of each component."""
        return self.variance_ratios.map(_gain)

    @cached_property
    def range_gain_of_perfect_rate(self) -> Expr:
        """The gain in range for C → ∞: what is left to estimate is one constant from k ranges."""
        return _gain(limit(self.variance_ratios[0,], C))

    @cached_property
    def range_gain_bound(self) -> Expr:
        """The least upper bound of the gain in range over all k and C: its limit for C → ∞ and then k → ∞."""
        return 1 - sp.sqrt(limit(limit(self.variance_ratios[0,], C), k))


def limit(quotient: Expr, symbol: Symbol) -> Expr:
    """The limit of a rational function for a symbol that grows without bound.

    Raises:
        ValueError: it grows without bound itself.
    """
    numerator, denominator = (_leading(part, symbol) for part in sp.fraction(sp.together(quotient)))
    if numerator[0] > denominator[0]:
        raise ValueError(f"{quotient} has no finite limit for large {symbol}")
    return sp.factor(numerator[1] / denominator[1]) if numerator[0] == denominator[0] else sp.Integer(0)


def _leading(polynomial: Expr, symbol: Symbol) -> tuple[int, Expr]:
    """The degree in a symbol and the coefficient of that power."""
    by_power: dict[int, list[Expr]] = {}
    for term in sp.Add.make_args(sp.expand(polynomial)):
        power = int(term.as_powers_dict().get(symbol, sp.Integer(0)))
        by_power.setdefault(power, []).append(term / symbol**power)
    highest = max(by_power)
    return highest, sp.Add(*by_power[highest])


def _gain(ratio: Expr) -> Expr:
    return sp.factor(1 - ratio) / (1 + sp.sqrt(ratio))
